package javax.microedition.lcdui;

import lejos.nxt.LCD;

/**
 * Draws lines, shapes, texts and pictures on the display or into an Image.
 *
 * <p>Dot 0, 0 is the upper left one. An anchor says which point of a text or picture is meant by a place, such as
 * TOP | HCENTER; 0 is the upper left one. Nothing shows beyond the edges.
 */
public class Graphics {
    /** The anchor is in the middle between left and right. */
    public static final int HCENTER = 1;

    /** The anchor is in the middle between top and bottom; for pictures. */
    public static final int VCENTER = 2;

    /** The anchor is on the left. */
    public static final int LEFT = 4;

    /** The anchor is on the right. */
    public static final int RIGHT = 8;

    /** The anchor is at the top. */
    public static final int TOP = 16;

    /** The anchor is below. */
    public static final int BOTTOM = 32;

    /** The anchor is the line on which the letters stand; for texts. */
    public static final int BASELINE = 64;

    /** Lines without gaps. */
    public static final int SOLID = 0;

    /** Lines of dots. */
    public static final int DOTTED = 1;

    /** The colour black. */
    public static final int BLACK = 0;

    /** The colour white. */
    public static final int WHITE = 0xffffff;

    private final Dots dots;
    private int color = BLACK;
    private int strokeStyle = SOLID;
    private Font font = Font.getDefaultFont();
    private int left;
    private int top;

    /** Makes one that draws on the display. */
    public Graphics() {
        this(LCD.getDisplay(), LCD.SCREEN_WIDTH, LCD.SCREEN_HEIGHT);
    }

    Graphics(byte[] data, int width, int height) {
        dots = new Dots(data, width, height);
    }

    /** Gives how many dots it is wide. */
    public int getWidth() {
        return dots.width;
    }

    /** Gives how many dots it is high. */
    public int getHeight() {
        return dots.height;
    }

    /** Makes everything white. */
    public void clear() {
        dots.fill(0, 0, dots.width, dots.height, LCD.ROP_CLEAR);
    }

    /** Gives the font of texts. */
    public Font getFont() {
        return font;
    }

    /** Sets the font of texts. */
    public void setFont(Font f) {
        font = f;
    }

    /** Gives the colour in which a colour shows: black if it is 0, and white otherwise. */
    public int getDisplayColor(int color) {
        return color == BLACK ? BLACK : WHITE;
    }

    /** Sets the colour, such as Graphics.BLACK; everything that is not black draws white. */
    public void setColor(int rgb) {
        color = rgb;
    }

    /** Sets the colour by its red, green and blue, 0 to 255; everything that is not black draws white. */
    public void setColor(int red, int green, int blue) {
        if ((red & 0xff) != red || (green & 0xff) != green || (blue & 0xff) != blue) {
            throw new IllegalArgumentException("bad color value");
        }
        setColor(red << 16 | green << 8 | blue);
    }

    /** Gives the colour. */
    public int getColor() {
        return color;
    }

    /** Gives the red of the colour, 0 to 255. */
    public int getRedComponent() {
        return color >> 16 & 0xff;
    }

    /** Gives the green of the colour, 0 to 255. */
    public int getGreenComponent() {
        return color >> 8 & 0xff;
    }

    /** Gives the blue of the colour, 0 to 255. */
    public synchronized int getBlueComponent() {
        return color & 0xff;
    }

    /** Gives how lines are drawn, SOLID or DOTTED. */
    public int getStrokeStyle() {
        return strokeStyle;
    }

    /** Sets how lines are drawn, SOLID or DOTTED. */
    public void setStrokeStyle(int style) {
        if (style != SOLID && style != DOTTED) throw new IllegalArgumentException();
        strokeStyle = style;
    }

    /** Moves dot 0, 0, seen from where it is now. */
    public synchronized void translate(int x, int y) {
        left += x;
        top += y;
    }

    /** Gives how many dots dot 0, 0 is right of the left edge. */
    public synchronized int getTranslateX() {
        return left;
    }

    /** Gives how many dots dot 0, 0 is below the upper edge. */
    public synchronized int getTranslateY() {
        return top;
    }

    /** Writes a text whose anchor is at x, y. */
    public void drawString(String str, int x, int y, int anchor) {
        drawString(str, x, y, anchor, false);
    }

    /** Writes a text whose anchor is at x, y, and says whether it is to be white on black. */
    public void drawString(String str, int x, int y, int anchor, boolean inverted) {
        int atX = left + x;
        int atY = top + y;
        if (anchor != 0 && (anchor & LEFT) == 0) {
            if ((anchor & RIGHT) != 0) atX -= font.stringWidth(str);
            else if ((anchor & HCENTER) != 0) atX -= font.stringWidth(str) / 2;
        }
        if (anchor != 0 && (anchor & TOP) == 0) {
            if ((anchor & BASELINE) != 0) atY -= font.base;
            else if ((anchor & BOTTOM) != 0) atY -= font.height;
        }
        boolean isBlack = inverted ? color == WHITE : color == BLACK;
        int length = str.length();
        if (inverted) dots.fill(atX, atY, length * font.width, font.height, operation());
        int drawn = isBlack ? LCD.ROP_OR : LCD.ROP_ANDINVERTED;
        for (int i = 0; i < length; i++) dots.character(font, str.charAt(i), atX + i * font.width, atY, drawn);
    }

    /** Writes so many characters of a text from a place on. */
    public void drawSubstring(String str, int offset, int len, int x, int y, int anchor) {
        if (isOutside(offset, len, str.length())) throw new StringIndexOutOfBoundsException();
        drawString(str.substring(offset, offset + len), x, y, anchor);
    }

    /** Writes a character. */
    public void drawChar(char character, int x, int y, int anchor) {
        drawString(String.valueOf(character), x, y, anchor);
    }

    /** Writes so many characters of an array from a place on. */
    public void drawChars(char[] data, int offset, int length, int x, int y, int anchor) {
        if (isOutside(offset, length, data.length)) throw new ArrayIndexOutOfBoundsException();
        drawString(new String(data, offset, length), x, y, anchor);
    }

    private static boolean isOutside(int offset, int length, int all) {
        return offset < 0 || length < 0 || offset > all || length > all || offset + length > all;
    }

    /** Draws a picture whose anchor is at x, y. */
    public void drawImage(Image src, int x, int y, int anchor) {
        drawRegionRop(src, 0, 0, src.getWidth(), src.getHeight(), x, y, anchor, LCD.ROP_COPY);
    }

    /** Draws a part of a picture, turned round as a constant of Sprite says. */
    public void drawRegion(Image src, int sx, int sy, int w, int h, int transform, int x, int y, int anchor) {
        drawRegionRop(src, sx, sy, w, h, transform, x, y, anchor, LCD.ROP_COPY);
    }

    /** Combines a part of a picture, null for this one, with what is there, as a constant ROP of LCD says. */
    public void drawRegionRop(Image src, int sx, int sy, int w, int h, int x, int y, int anchor, int rop) {
        Dots from = src == null ? dots : src.dots();
        dots.draw(from, sx, sy, w, h, left + horizontal(x, w, anchor), top + vertical(y, h, anchor), rop);
    }

    /** Combines a part of a picture, turned round as a constant of Sprite says, with what is there. */
    public void drawRegionRop(Image src, int sx, int sy, int w, int h, int transform, int x, int y, int anchor,
            int rop) {
        if (transform == 0) {
            drawRegionRop(src, sx, sy, w, h, x, y, anchor, LCD.ROP_COPY);
            return;
        }
        Turning turning = new Turning(transform, w, h);
        turning.draw(src.dots(), sx, sy, dots, left + horizontal(x, turning.width, anchor),
            top + vertical(y, turning.height, anchor), rop);
    }

    /** Copies a part of what is there to a place. */
    public void copyArea(int sx, int sy, int w, int h, int x, int y, int anchor) {
        drawRegionRop(null, sx, sy, w, h, x, y, anchor, LCD.ROP_COPY);
    }

    private static int horizontal(int x, int width, int anchor) {
        int across = anchor & (LEFT | RIGHT | HCENTER);
        if (across == RIGHT) return x - width;
        return across == HCENTER ? x - (width >> 1) : x;
    }

    private static int vertical(int y, int height, int anchor) {
        int down = anchor & (TOP | BOTTOM | VCENTER);
        if (down == BOTTOM) return y - height;
        return down == VCENTER ? y - (height >> 1) : y;
    }

    /** Draws a line from one dot to another. */
    public void drawLine(int x0, int y0, int x1, int y1) {
        dots.line(left + x0, top + y0, left + x1, top + y1, strokeStyle, operation());
    }

    /** Draws a rectangle; after translate, it is moved twice as far, as leJOS NXJ does it. */
    public void drawRect(int x, int y, int width, int height) {
        if (width < 0 || height < 0) return;
        int atX = left + x;
        int atY = top + y;
        int right = atX + width;
        int bottom = atY + height;
        if (height == 0 || width == 0) {
            drawLine(atX, atY, right, bottom);
            return;
        }
        drawLine(atX, atY, right - 1, atY);
        drawLine(right, atY, right, bottom - 1);
        drawLine(right, bottom, atX + 1, bottom);
        drawLine(atX, bottom, atX, atY + 1);
    }

    /** Fills a rectangle. */
    public void fillRect(int x, int y, int w, int h) {
        if (w >= 0 && h >= 0) dots.fill(left + x, top + y, w, h, operation());
    }

    /** Draws a rectangle whose corners are parts of an ellipse, so many dots wide and high. */
    public void drawRoundRect(int x, int y, int width, int height, int arcWidth, int arcHeight) {
        int atX = left + x;
        int atY = top + y;
        int a = arcWidth / 2;
        int b = arcHeight / 2;
        drawLine(atX, atY + b, atX, atY + height - b);
        drawLine(atX + width, atY + b, atX + width, atY + height - b);
        drawLine(atX + a, atY, atX + width - a, atY);
        drawLine(atX + a, atY + height, atX + width - a, atY + height);
        new RoundCorners(dots, operation())
            .draw(atX + width / 2, atY + height / 2, width / 2 - a, height / 2 - b, a, b);
    }

    /** Draws a part of an ellipse in a rectangle: from an angle on, by an angle, in degrees; 0 is on the right. */
    public void drawArc(int x, int y, int width, int height, int startAngle, int arcAngle) {
        new Arc(dots, operation(), strokeStyle == DOTTED, false)
            .draw(left + x, top + y, width, height, startAngle, arcAngle, 0, 0);
    }

    /** Fills a part of an ellipse in a rectangle: from an angle on, by an angle, in degrees; 0 is on the right. */
    public void fillArc(int x, int y, int width, int height, int startAngle, int arcAngle) {
        new Arc(dots, operation(), false, true)
            .draw(left + x, top + y, width, height, startAngle, arcAngle, left, top);
    }

    private int operation() {
        return color == BLACK ? LCD.ROP_SET : LCD.ROP_CLEAR;
    }
}
