import javax.microedition.lcdui.Font;
import javax.microedition.lcdui.Graphics;
import javax.microedition.lcdui.Image;
import javax.microedition.lcdui.game.Sprite;
import lejos.nxt.LCD;

/**
 * Lines, rectangles, circles, texts and turned pictures, as rows of dots.
 *
 * <p>As in leJOS NXJ, translate moves rectangles twice, and mirrored pictures of odd width are one dot too far right.
 */
public class ShapesOnTheDisplay {
    static final StringBuilder log = new StringBuilder();

    static void show(Image image) {
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                log.append((image.getData()[y / 8 * image.getWidth() + x] >> y % 8 & 1) == 0 ? '.' : '#');
            }
            log.append('\n');
        }
    }

    static int blackDots() {
        int count = 0;
        for (int y = 0; y < LCD.SCREEN_HEIGHT; y++) {
            for (int x = 0; x < LCD.SCREEN_WIDTH; x++) count += LCD.getPixel(x, y);
        }
        return count;
    }

    static void shapes() {
        Image image = Image.createImage(14, 9);
        Graphics g = image.getGraphics();
        g.drawRect(0, 0, 4, 3);
        g.fillRect(6, 0, 3, 2);
        g.drawLine(10, 0, 13, 2);
        g.setStrokeStyle(Graphics.DOTTED);
        g.drawLine(0, 5, 9, 5);
        g.setStrokeStyle(Graphics.SOLID);
        g.translate(1, 1);
        g.drawRect(8, 2, 2, 2);
        g.drawLine(0, 5, 3, 5);
        g.setColor(Graphics.WHITE);
        g.drawLine(1, 5, 1, 5);
        log.append(g.getTranslateX()).append(' ').append(g.getColor()).append(' ');
        log.append(g.getDisplayColor(0x123456) == Graphics.WHITE).append('\n');
        show(image);
    }

    static void circles() {
        Image image = Image.createImage(20, 10);
        Graphics g = image.getGraphics();
        g.drawArc(0, 0, 8, 8, 0, 360);
        g.fillArc(10, 0, 8, 8, 0, 90);
        show(image);
    }

    static void turns() {
        Image flag = new Image(3, 4, new byte[] {15, 1, 3});
        show(flag);
        log.append("-\n");
        show(Image.createImage(flag, 0, 0, 3, 4, Sprite.TRANS_ROT90));
        log.append("-\n");
        show(Image.createImage(flag, 0, 0, 3, 4, Sprite.TRANS_MIRROR));
        log.append("-\n");
        show(Image.createImage(flag, 0, 0, 3, 4, Sprite.TRANS_ROT180));
        log.append("-\n");
        show(Image.createImage(flag, 0, 0, 3, 4, Sprite.TRANS_ROT270));
    }

    public static void main(String[] arguments) {
        shapes();
        circles();
        turns();
        Graphics g = new Graphics();
        g.setFont(Font.getLargeFont());
        log.append(g.getFont().stringWidth("leJOS")).append(' ').append(g.getFont().getHeight()).append(' ');
        g.drawString("NXT", 50, 20, Graphics.HCENTER | Graphics.BASELINE);
        int large = blackDots();
        g.clear();
        g.setFont(Font.getFont(0, 0, Font.SIZE_SMALL));
        g.drawString("NXT", 0, 0, 0);
        int small = blackDots();
        log.append(large > 3 * small && small > 15).append(' ').append(Font.getSmallFont().getBaselinePosition()).append('\n');
        g.clear();
        g.setFont(Font.getDefaultFont());
        g.drawString("robot", 98, 9, Graphics.RIGHT | Graphics.TOP, true);
        log.append(LCD.getPixel(68, 16)).append(LCD.getPixel(97, 16)).append(LCD.getPixel(98, 16)).append('\n');
        try {
            g.setColor(256, 0, 0);
        } catch (IllegalArgumentException e) {
            log.append(e.getMessage());
        }
        LCD.clear();
        System.out.println(log);
    }
}

// It prints:
// expect 1 16777215 true
// expect #####.###.#...
// expect #...#.###..##.
// expect #...#........#
// expect #####.........
// expect ..........###.
// expect ##.#.#.#.##.#.
// expect .#.##.....###.
// expect ..............
// expect ..............
// expect ....#.........#.....
// expect ..##.##.......###...
// expect .##...##......####..
// expect .#.....#......####..
// expect #.......#.....#####.
// expect .#.....#............
// expect .##...##............
// expect ..##.##.............
// expect ....#...............
// expect ....................
// expect ###
// expect #.#
// expect #..
// expect #..
// expect -
// expect ####
// expect ...#
// expect ..##
// expect -
// expect .##
// expect .#.
// expect ...
// expect ...
// expect -
// expect ...
// expect ...
// expect .#.
// expect .##
// expect -
// expect ....
// expect ##..
// expect #...
// expect 50 16 true 5
// expect 110
// expect bad color value
