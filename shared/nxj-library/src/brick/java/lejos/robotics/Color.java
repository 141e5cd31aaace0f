package lejos.robotics;

/** A colour as its red, green and blue, and the numbers of colours. */
public class Color {
    /** The number of red. */
    public static final int RED = 0;

    /** The number of green. */
    public static final int GREEN = 1;

    /** The number of blue. */
    public static final int BLUE = 2;

    /** The number of yellow. */
    public static final int YELLOW = 3;

    /** The number of magenta. */
    public static final int MAGENTA = 4;

    /** The number of orange. */
    public static final int ORANGE = 5;

    /** The number of white. */
    public static final int WHITE = 6;

    /** The number of black. */
    public static final int BLACK = 7;

    /** The number of pink. */
    public static final int PINK = 8;

    /** The number of gray. */
    public static final int GRAY = 9;

    /** The number of light gray. */
    public static final int LIGHT_GRAY = 10;

    /** The number of dark gray. */
    public static final int DARK_GRAY = 11;

    /** The number of cyan. */
    public static final int CYAN = 12;

    /** The number of no colour at all. */
    public static final int NONE = -1;

    private final int red;
    private final int green;
    private final int blue;
    private final int id;

    /** Makes one of so much red, green and blue, each 0 to 255; its number is that of red, whatever it looks like. */
    public Color(int red, int green, int blue) {
        this(red, green, blue, RED);
    }

    /** Makes one of so much red, green and blue, which has a number. */
    public Color(int red, int green, int blue, int color) {
        this.red = red;
        this.green = green;
        this.blue = blue;
        id = color;
    }

    /** Gives how red it is, 0 to 255. */
    public int getRed() {
        return red;
    }

    /** Gives how green it is, 0 to 255. */
    public int getGreen() {
        return green;
    }

    /** Gives how blue it is, 0 to 255. */
    public int getBlue() {
        return blue;
    }

    /** Gives the number of the colour, such as Color.RED. */
    public int getColor() {
        return id;
    }
}
