import josx.platform.rcx.LCD;
import josx.platform.rcx.Memory;

public class MemoryBytes {
    public static void main(String[] arguments) {
        synchronized (Memory.MONITOR) {
            Memory.writeByte(0xF004, (byte) 200);
            LCD.showNumber(Memory.readByte(0xF004) < 0 ? 1 : 2); // brick shows: 2 // forgiving shows: 1
            LCD.showNumber((byte) Memory.readByte(0xF004) & 0xFF); // shows: 200
            Memory.setBit(0xF004, 0, 1);
            Memory.setBit(0xF004, 7, 0);
            LCD.showNumber(Memory.readByte(0xF004)); // shows: 73
            Memory.writeShort(0xF004, (short) 1234);
            LCD.showNumber(Memory.readShort(0xF004)); // shows: 1234
            LCD.showNumber(Memory.readByte(0xF004)); // shows: 4
            byte[] bytes = {0, 7};
            int address = Memory.getDataAddress(bytes);
            LCD.showNumber(Memory.readByte(address + 1)); // shows: 7
            Memory.writeByte(address, (byte) 9);
            LCD.showNumber(bytes[0]); // shows: 9
        }
    }
}
