// Presses P1 of a remote control and drives on while red drives: that wakes the program of every brick that sees it.

import josx.platform.rcx.Motor;
import josx.platform.rcx.Serial;

class RemoteMessage {
    /** What LEGO's remote control sends: its opcode, and one of its sixteen buttons. */
    static final byte REMOTE = (byte) 0xD2;
    static final byte BUTTON_P1 = 0x02;

    public static void main(String[] args) throws InterruptedException {
        byte[] call = {REMOTE, BUTTON_P1, 0};
        for (int calls = 0; calls < 5; calls++) {
            Serial.sendPacket(call, 0, call.length);
            Motor.A.forward();
            Motor.C.forward();
            Thread.sleep(900); // 18 cm
            Motor.A.stop();
            Motor.C.stop();
            Thread.sleep(1100); // until red stands still
        }
    }
}
