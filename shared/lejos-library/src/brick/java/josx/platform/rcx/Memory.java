package josx.platform.rcx;

/** The brick's memory, byte by byte. */
public class Memory {
    /** Synchronize on it while a routine of the ROM works with an array of yours. */
    public static final Object MONITOR = new Object();

    /** Makes an object, of which nobody has a use: call the methods on the class. */
    public Memory() {
    }

    /** Gives the byte at an address. */
    public static native byte readByte(int address);

    /** Changes the byte at an address. */
    public static native void writeByte(int address, byte value);

    /** Changes one bit, 0 to 7, of the byte at an address. */
    public static native void setBit(int address, int bit, int value);

    /** Gives the address of an array's first element. */
    public static native int getDataAddress(Object array);

    /** Gives the number in the two bytes at an address, the high one first. */
    public static short readShort(int address) {
        return (short) (readByte(address) << 8 | readByte(address + 1) & 0xFF);
    }

    /** Changes the two bytes at an address, the high one first. */
    public static void writeShort(int address, short value) {
        writeByte(address, (byte) (value >> 8));
        writeByte(address + 1, (byte) value);
    }
}
