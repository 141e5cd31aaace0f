import josx.platform.rcx.LCD;
import josx.platform.rcx.SensorConstants;

public class NativesOfAPupil {
    /** A brick finds these by name and parameters, in whichever class they are. */
    static class Brick {
        static native void call(short address);

        static native void call(short address, short a);

        static native void call(short address, short a, short b);

        static native void call(short address, short a, short b, short c);

        static native void call(short address, short a, short b, short c, short d);

        static native byte readByte(int address);

        static native void writeByte(int address, byte value);

        static native void setBit(int address, int bit, int value);

        static native int getDataAddress(Object array);

        static native int readSensorValue(int port, int kind);

        static native void setSensorValue(int port, int value, int kind);

        static native void setThrottle(int readings);

        static native void resetSerial();

        native long freeMemory();

        static native long totalMemory();
    }

    static native void test(String message, boolean isTrue);

    static native void testEQ(String message, int expected, int actual);

    static native long currentTimeMillis();

    static native void sleep(long milliseconds) throws InterruptedException;

    static native Thread currentThread();

    static native boolean interrupted();

    static native void yield();

    static native int floatToIntBits(float number);

    static native float intBitsToFloat(int bits);

    static native void exit(int code);

    static void show(int number) {
        Brick.call((short) 0x1ff2, (short) 0x301f, (short) number, (short) 0x3002);
        Brick.call((short) 0x27c8); // shows: 1 2 3 4 5 6 7 8 9
    }

    public static void main(String[] arguments) throws InterruptedException {
        show(1);
        int began = (int) currentTimeMillis();
        sleep(50);
        show((int) currentTimeMillis() - began >= 50 ? 2 : 0);
        byte[] bytes = {6, 7};
        int address = Brick.getDataAddress(bytes);
        Brick.writeByte(address + 1, (byte) 2);
        Brick.setBit(address + 1, 0, 1);
        show(Brick.readByte(address + 1));
        show(bytes[1] + 1);
        show((int) intBitsToFloat(floatToIntBits(5.5f)));
        Brick.setSensorValue(0, SensorConstants.SENSOR_MODE_RAW, 0);
        Brick.setThrottle(1);
        sleep(10);
        show(Brick.readSensorValue(0, SensorConstants.CANONICAL_VALUE) == 300 ? 6 : 0);
        int free = (int) new Brick().freeMemory();
        show(free > 0 && free < (int) Brick.totalMemory() ? 7 : 0);
        Thread.currentThread().interrupt();
        yield();
        show(currentThread() == Thread.currentThread() && interrupted() ? 8 : 0);
        Brick.resetSerial();
        Brick.call((short) 0x3250, (short) 0x1770);
        Brick.call((short) 0x299a, (short) 0x4004, (short) 0);
        Brick.call((short) 0x343e, (short) 0x1775, (short) 0, (short) address, (short) 2);
        test("right", true);
        testEQ("right", 4, 2 + 2);
        try {
            test("wrong", false);
        } catch (Error wrong) {
            show(wrong.getMessage() == null ? 9 : 0);
        }
        try {
            testEQ("wrong", 4, 5);
        } catch (Error wrong) {
            exit(0);
        }
        LCD.showNumber(99);
    }
}
// sensor 1 at 0: raw 300
