// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
package hindsight.spy;

import hindsight.grid_t;
import java.awt.image.BufferedImage;
import javax.swing.Action;
import javax.swing.JDesktopPane;
import lcm.spy.ChannelData;
import lcm.spy.SpyPlugin;

/** Shows a hindsight.grid_t, north up: no cost white, high cost orange, lethal dark red. */
public final class GridPlugin implements SpyPlugin {
  private static final int[] COLOURS = {0xFFFFFF, 0xF0A030, 0x901010};
  private static final int SHOWN_PX = 400;

  @Override
  public boolean canHandle(long fingerprint) {
    return fingerprint == grid_t.LCM_FINGERPRINT;
  }

  @Override
  public Action getAction(JDesktopPane desktop, ChannelData channel) {
    return new PictureWindow("Grid", channel, message -> draw((grid_t) message));
  }

  private static BufferedImage draw(grid_t grid) {
    if (grid.width <= 0 || grid.height <= 0 || grid.size != grid.width * grid.height) return null;
    int cell = Math.max(1, SHOWN_PX / grid.width);  // [px]
    BufferedImage picture =
        new BufferedImage(grid.width * cell, grid.height * cell, BufferedImage.TYPE_INT_RGB);
    for (int y = 0; y < picture.getHeight(); ++y) {
      int row = grid.height - 1 - y / cell;
      for (int x = 0; x < picture.getWidth(); ++x) {
        int cost = grid.cost[row * grid.width + x / cell];
        picture.setRGB(x, y, cost >= 0 && cost < COLOURS.length ? COLOURS[cost] : 0);
      }
    }
    return picture;
  }
}
