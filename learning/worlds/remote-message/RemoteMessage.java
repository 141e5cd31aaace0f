// Presses P1 of a remote control once: that wakes the program of every brick that sees it.

import josx.platform.rcx.Serial;

class RemoteMessage {
    /** What LEGO's remote control sends: its opcode, and one of its sixteen buttons. */
    static final byte REMOTE = (byte) 0xD2;
    static final byte BUTTON_P1 = 0x02;

    public static void main(String[] args) throws InterruptedException {
        byte[] call = {REMOTE, BUTTON_P1, 0};
        Serial.sendPacket(call, 0, call.length);
        Thread.sleep(2000); // while red drives
    }
}
