package javax.microedition.lcdui;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;

/**
 * A picture of black and white dots.
 *
 * <p>It has rows of 8 dots: dot x, y is bit y % 8 of the byte at y / 8 * width + x, 1 for black.
 */
public class Image {
    /** The four letters LNI0. */
    private static final int HEADER = 0x4c4e4930;

    private final int width;
    private final int height;
    private final byte[] data;

    /** Makes one, so many dots wide and high, whose dots are in an array. */
    public Image(int width, int height, byte[] data) {
        this.width = width;
        this.height = height;
        this.data = data;
    }

    /** Makes a white one, so many dots wide and high. */
    public static Image createImage(int width, int height) {
        return new Image(width, height, new byte[width * (height + 7) / 8]);
    }

    /** Reads one: the letters LNI0, its width and its height in two bytes each, and its bytes. */
    public static Image createImage(InputStream s) throws IOException {
        DataInputStream in = new DataInputStream(s);
        int header = in.readInt();
        int width = in.readUnsignedShort();
        int height = in.readUnsignedShort();
        if (header != HEADER) throw new IOException("File format error!");
        byte[] data = new byte[width * ((height + 7) / 8)];
        in.readFully(data);
        return new Image(width, height, data);
    }

    /** Makes one of a part of another, turned round as a constant of Sprite says. */
    public static Image createImage(Image image, int x, int y, int w, int h, int transform) {
        boolean isUpright = Turning.isUpright(transform);
        Image turned = createImage(isUpright ? h : w, isUpright ? w : h);
        turned.getGraphics().drawRegion(image, x, y, w, h, transform, 0, 0, 0);
        return turned;
    }

    /** Gives how many dots it is wide. */
    public int getWidth() {
        return width;
    }

    /** Gives how many dots it is high. */
    public int getHeight() {
        return height;
    }

    /** Gives the array with its dots. */
    public byte[] getData() {
        return data;
    }

    /** Gives what draws into it. */
    public Graphics getGraphics() {
        return new Graphics(data, width, height);
    }

    Dots dots() {
        return new Dots(data, width, height);
    }
}
