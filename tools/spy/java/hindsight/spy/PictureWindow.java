// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
package hindsight.spy;

import java.awt.event.ActionEvent;
import java.awt.image.BufferedImage;
import java.util.function.Function;
import javax.swing.AbstractAction;
import javax.swing.ImageIcon;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.Timer;
import lcm.spy.ChannelData;

/** The entry of a channel's menu that opens a window with the channel's latest message drawn as a picture. */
final class PictureWindow extends AbstractAction {
  private static final int REFRESH_MS = 100;
  private final ChannelData channel;
  private final Function<Object, BufferedImage> draw;

  /** {@code draw} may return null for a message that shows nothing; the window then keeps what it has. */
  PictureWindow(String name, ChannelData channel, Function<Object, BufferedImage> draw) {
    super(name);
    this.channel = channel;
    this.draw = draw;
  }

  @Override
  public void actionPerformed(ActionEvent event) {
    JLabel picture = new JLabel();
    JFrame window = new JFrame(getValue(NAME) + " of " + channel.name);
    window.setDefaultCloseOperation(JFrame.DISPOSE_ON_CLOSE);
    window.add(picture);
    window.setVisible(true);
    Timer refresh = new Timer(REFRESH_MS, tick -> {
      if (!window.isDisplayable()) {
        ((Timer) tick.getSource()).stop();
        return;
      }
      Object message = channel.last;
      BufferedImage drawn = message == null ? null : draw.apply(message);
      if (drawn == null) return;
      picture.setIcon(new ImageIcon(drawn));
      window.pack();
    });
    refresh.setInitialDelay(0);
    refresh.start();
  }
}
