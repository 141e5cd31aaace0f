import josx.platform.rcx.LCD;
import josx.rcxcomm.LNPAddressingHandler;
import josx.rcxcomm.LNPIntegrityHandler;
import josx.rcxcomm.PacketHandler;

public class LnpHandlers {
    /** What is sent comes back. */
    static class Mirror extends PacketHandler {
        private final byte[] bytes = new byte[20];
        private int count;

        public boolean sendPacket(byte[] packet, int length) {
            for (int index = 0; index < length; index++) bytes[index] = packet[index];
            count = length;
            return true;
        }

        public int receivePacket(byte[] buffer) {
            int length = count;
            count = 0;
            for (int index = 0; index < length; index++) buffer[index] = bytes[index];
            return length;
        }

        public boolean isPacketAvailable() {
            return count > 0;
        }
    }

    public static void main(String[] arguments) {
        byte[] letters = {65, 66, 67};
        byte[] buffer = new byte[10];
        Mirror mirror = new Mirror();
        LNPIntegrityHandler sums = new LNPIntegrityHandler(mirror, (byte) 0xF0);
        LCD.showNumber(sums.receivePacket(buffer)); // shows: 0
        sums.sendPacket(letters, 3);
        LCD.showNumber(mirror.count); // shows: 6
        LCD.showNumber((mirror.bytes[0] & 0xFF) * 10 + mirror.bytes[1]); // shows: 2403
        LCD.showNumber(mirror.bytes[5] & 0xFF); // shows: 184
        LCD.showNumber(sums.isPacketAvailable() ? 1 : 0); // shows: 1
        LCD.showNumber(sums.isAddressing() ? 1 : 0); // shows: 0
        LCD.showNumber(sums.receivePacket(buffer) * 100 + buffer[2]); // shows: 367
        sums.sendPacket(letters, 3);
        mirror.bytes[3]++;
        LCD.showNumber(sums.isPacketAvailable() ? 1 : 0); // shows: 0
        sums.setOp((byte) 0xF1);
        LNPAddressingHandler post = new LNPAddressingHandler(sums);
        post.open((byte) 0x12, (byte) 0x12);
        post.sendPacket(letters, 2);
        LCD.showNumber(mirror.bytes[2] * 100 + mirror.bytes[1]); // shows: 1804
        LCD.showNumber(post.isPacketAvailable() && sums.isAddressing() ? 1 : 0); // shows: 1
        LCD.showNumber(post.receivePacket(buffer) * 100 + buffer[1]); // shows: 266
        post.open((byte) 0x12, (byte) 0x22);
        post.sendPacket(letters, 2);
        LCD.showNumber(post.isPacketAvailable() ? 1 : 0); // shows: 0
    }
}
