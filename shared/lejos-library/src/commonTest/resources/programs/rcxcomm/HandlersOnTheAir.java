import josx.rcxcomm.LLCHandler;
import josx.rcxcomm.LNPHandler;

public class HandlersOnTheAir {
    public static void main(String[] arguments) {
        byte[] buffer = new byte[8];
        LLCHandler bytes = new LLCHandler();
        bytes.sendPacket(new byte[] {(byte) 0xF1, 65, 50}, 3); // rom: 0x343e 0x1775 0 ? 2
        bytes.sendPacket(new byte[] {(byte) 0xF1, 65, 51}, 3); // rom: 0x343e 0x1775 0 ? 3
        if (bytes.isPacketAvailable()) bytes.receivePacket(buffer); // rom: 0x3426 ? 0x0000
        if (bytes.isAckAvailable()) bytes.receiveAck(buffer); // rom: 0x3426 ? 0x0000
        LNPHandler pieces = new LNPHandler();
        pieces.sendPacket(new byte[] {(byte) 0xF0, 4, 1, 2, 3, 4, 9}, 7); // rom: 0x343e 0x1775 0 ? 6 | 0x343e 0x1775 0 ? 3
        if (pieces.isPacketAvailable() || pieces.isAddressing()) pieces.receivePacket(buffer); // rom: 0x3426 ? 0x0000
    }
}
