package lejos.nxt;

/** The brick itself. */
public class NXT {
    /** Makes one, which nobody needs. */
    public NXT() {
    }

    /** Switches the brick off. */
    public static native void shutDown();

    /**
     * Ends the program.
     *
     * @hidden
     */
    public static void exit(int code) {
        System.exit(code);
    }

    /** Gives the version of the firmware: the highest number of three. */
    public static int getFirmwareMajorVersion() {
        return getFirmwareRawVersion() >> 16 & 0xFF;
    }

    /** Gives the version of the firmware: the number in the middle. */
    public static int getFirmwareMinorVersion() {
        return getFirmwareRawVersion() >> 8 & 0xFF;
    }

    /** Gives the version of the firmware: the last number. */
    public static int getFirmwareRevision() {
        return getFirmwareRawVersion() & 0xFF;
    }

    /** Gives the version of the firmware: the last number. */
    public static int getFirmwarePatchLevel() {
        return getFirmwareRawVersion() & 0xFF;
    }

    /** Gives the version of the firmware: three numbers of eight bits each. */
    public static native int getFirmwareRawVersion();
}
