import josx.platform.rcx.LCD;
import josx.platform.rcx.Message;
import josx.platform.rcx.Opcode;
import josx.platform.rcx.Serial;
import josx.platform.rcx.SerialListener;

public class Messages implements SerialListener {
    public void packetAvailable(byte[] packet, int length) {
    }

    public static void main(String[] arguments) {
        LCD.showNumber(Message.isAvailable() ? 1 : 0); // shows: 0
        LCD.showNumber(Message.get()); // shows: 0
        Message.send((byte) 3);
        Message.clear();
        Serial.addSerialListener(new Messages());
        LCD.showNumber(Opcode.OPCODE_ALIVE); // shows: 16
    }
}
