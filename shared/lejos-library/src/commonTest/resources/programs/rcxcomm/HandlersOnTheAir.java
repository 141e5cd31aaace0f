import josx.platform.rcx.LCD;
import josx.rcxcomm.LLCHandler;
import josx.rcxcomm.LNPHandler;

/** Alone, nothing comes. */
public class HandlersOnTheAir {
    static int ask(boolean answer) {
        return answer ? 1 : 0;
    }

    public static void main(String[] arguments) {
        byte[] buffer = new byte[8];
        LLCHandler bytes = new LLCHandler();
        LCD.showNumber(ask(bytes.sendPacket(new byte[] {(byte) 0xF1, 65, 50}, 3))); // shows: 1
        LCD.showNumber(ask(bytes.isPacketAvailable())); // shows: 0
        LCD.showNumber(ask(bytes.isAckAvailable())); // shows: 0
        LCD.showNumber(bytes.receivePacket(buffer)); // shows: 3
        LCD.showNumber(bytes.receiveAck(buffer)); // shows: 2
        LNPHandler packets = new LNPHandler();
        LCD.showNumber(ask(packets.sendPacket(new byte[] {(byte) 0xF0, 4, 1, 2, 3, 4, -3}, 7))); // shows: 1
        LCD.showNumber(ask(packets.isPacketAvailable())); // shows: 0
        LCD.showNumber(ask(packets.isAddressing())); // shows: 0
        LCD.showNumber(packets.receivePacket(buffer)); // shows: 0
    }
}
