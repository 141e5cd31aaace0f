package josx.platform.rcx;

/** The brick's batteries. */
public class Battery {
    // The ROM writes into it, so that its address has to stay the same.
    private static final short[] measured = new short[1];
    private static final int measuredAddress = Memory.getDataAddress(measured);

    /** Makes an object, of which nobody has a use: call the methods on the class. */
    public Battery() {
    }

    /** Gives the voltage as the brick measures it: 320 are about 9 volts. */
    public static int getVoltageInternal() {
        synchronized (Memory.MONITOR) {
            ROM.call((short) 0x29f2, (short) 0x4001, (short) measuredAddress);
            return measured[0];
        }
    }

    /** Gives the voltage in thousandths of a volt. */
    public static int getVoltageMilliVolt() {
        return getVoltageInternal() * 43988 / 1560;
    }

    /** Gives the voltage in volts. */
    public static float getVoltage() {
        return getVoltageMilliVolt() / 1000f;
    }
}
