package josx.platform.rcx;

/** Sends and receives packets of infrared light. */
public class Serial {
    private static final int MOST_LISTENERS = 4;
    private static final int LONGEST_PACKET = 16;

    /** While this byte of the memory holds IDLE, nothing is being sent. */
    private static final int SEND_STATE = 0xEF93;
    private static final int IDLE = 0x4F;

    // The ROM writes into it: a count in the first, a yes or no in the second byte. Who changes or tells the listeners locks it.
    private static final byte[] answer = new byte[2];
    private static final int answerAddress = Memory.getDataAddress(answer);

    private static SerialListener[] listeners;
    private static byte[] packet;
    private static int count;

    private Serial() {
    }

    /** Puts the packet that has come into an array and says how many bytes it has. */
    public static int readPacket(byte[] buffer) {
        synchronized (Memory.MONITOR) {
            answer[0] = 0;
            ROM.call((short) 0x33b0, (short) Memory.getDataAddress(buffer), (short) buffer.length, (short) answerAddress);
            return answer[0];
        }
    }

    /** Sets the array that large transfers go into; it has to be large enough. */
    public static void setDataBuffer(byte[] data) {
        ROM.call((short) 0x327c, (short) 0x1771, (short) Memory.getDataAddress(data), (short) 0);
    }

    /** Says whether a packet has come. */
    public static boolean isPacketAvailable() {
        synchronized (Memory.MONITOR) {
            ROM.call((short) 0x3426, (short) (answerAddress + 1), (short) 0);
            return answer[1] != 0;
        }
    }

    /** Sends a part of an array; says false if another packet is still being sent. */
    public static boolean sendPacket(byte[] buffer, int first, int length) {
        if (isSending()) return false;
        ROM.call((short) 0x343e, (short) 0x1775, (short) 0, (short) (Memory.getDataAddress(buffer) + first), (short) length);
        return true;
    }

    /** Lets the light reach far. */
    public static void setRangeLong() {
        ROM.call((short) 0x3250, (short) 0x1770);
    }

    /** Lets the light reach only near bricks. */
    public static void setRangeShort() {
        ROM.call((short) 0x3266, (short) 0x1770);
    }

    /** Begins anew with infrared light. */
    public static native void resetSerial();

    /** Says whether a packet is still being sent. */
    public static boolean isSending() {
        return Memory.readByte(SEND_STATE) != IDLE;
    }

    /** Waits until the packet is sent. */
    public static void waitTillSent() throws InterruptedException {
        while (isSending()) Thread.sleep(20);
    }

    /** Tells a listener from now on when a packet has come; there can be four. */
    public static void addSerialListener(SerialListener listener) {
        synchronized (answer) {
            if (listeners == null) {
                listeners = new SerialListener[MOST_LISTENERS];
                packet = new byte[LONGEST_PACKET];
            }
            listeners[count] = listener;
            count++;
        }
        ListenerThread.watch(Poll.SERIAL_MASK);
    }

    static void callListeners() {
        synchronized (answer) {
            if (!isPacketAvailable()) return;
            int length = readPacket(packet);
            for (int index = 0; index < count; index++) listeners[index].packetAvailable(packet, length);
        }
    }
}
