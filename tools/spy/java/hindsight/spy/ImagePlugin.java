// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
package hindsight.spy;

import bot_core.image_t;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import javax.imageio.ImageIO;
import javax.swing.Action;
import javax.swing.JDesktopPane;
import lcm.spy.ChannelData;
import lcm.spy.SpyPlugin;

/** Shows a bot_core.image_t that holds a JPEG. lcm-spy finds this class by itself. */
public final class ImagePlugin implements SpyPlugin {
  @Override
  public boolean canHandle(long fingerprint) {
    return fingerprint == image_t.LCM_FINGERPRINT;
  }

  @Override
  public Action getAction(JDesktopPane desktop, ChannelData channel) {
    return new PictureWindow("Picture", channel, message -> decode((image_t) message));
  }

  private static BufferedImage decode(image_t message) {
    try {
      return ImageIO.read(new ByteArrayInputStream(message.data));
    } catch (IOException damaged) {
      return null;
    }
  }
}
