package josx.platform.rcx;

/** The brick's built-in routines: in the end everything a program does to the robot is one of these calls. */
public class ROM {
    /** Makes an object, of which nobody has a use: call the methods on the class. */
    public ROM() {
    }

    /** Calls a routine. */
    public static native void call(short address);

    /** Calls a routine with one number. */
    public static native void call(short address, short a);

    /** Calls a routine with two numbers. */
    public static native void call(short address, short a, short b);

    /** Calls a routine with three numbers. */
    public static native void call(short address, short a, short b, short c);

    /** Calls a routine with four numbers. */
    public static native void call(short address, short a, short b, short c, short d);
}
