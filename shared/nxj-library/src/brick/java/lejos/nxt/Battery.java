package lejos.nxt;

/** The brick's battery. */
public class Battery {
    private Battery() {
    }

    /** Gives the voltage in thousandths of a volt. */
    public static int getVoltageMilliVolt() {
        return getBatteryStatus() & 0x3FFF;
    }

    /** Gives the voltage in volts. */
    public static float getVoltage() {
        return getVoltageMilliVolt() * 0.001f;
    }

    /** Says whether it is a pack that can be charged. */
    public static boolean isRechargeable() {
        return (getBatteryStatus() & 0x8000) != 0;
    }

    private static native int getBatteryStatus();
}
