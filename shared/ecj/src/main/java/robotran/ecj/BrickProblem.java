package robotran.ecj;

/** The numbers of the problems that are not ECJ's but a brick's. */
public final class BrickProblem {
    public static final int SWITCH = -1;
    public static final int LONG_ARITHMETIC = -2;
    public static final int FLOAT_REMAINDER = -3;
    public static final int ARRAY_TYPE_TEST = -4;
    public static final int CLASS_LITERAL = -5;
    public static final int TEXT_JOINED_IN_LOOP = -6;

    /** Its arguments are the divisor and what the brick takes it for. */
    public static final int DIVISOR_TOO_LARGE = -7;

    /** Its arguments are the length and the greatest there can be. */
    public static final int ARRAY_TOO_LONG = -8;

    /** A source is too long, or there are too many; its argument is how many UTF-16 characters there can be in all. */
    public static final int SOURCE_TOO_LONG = -9;

    /** Too much is inside each other. */
    public static final int NESTED_TOO_DEEPLY = -10;

    private BrickProblem() {}
}
