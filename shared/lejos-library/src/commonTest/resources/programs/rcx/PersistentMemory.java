import josx.platform.rcx.LCD;
import josx.platform.rcx.PersistentMemoryArea;

public class PersistentMemory {
    public static void main(String[] arguments) {
        PersistentMemoryArea area = PersistentMemoryArea.get(4711, 10);
        LCD.showNumber(area.readByte(9)); // shows: 0
        area.writeByte(9, (byte) 77);
        LCD.showNumber(PersistentMemoryArea.get(4711, 10).readByte(9)); // shows: 77
        try {
            area.readByte(10);
        } catch (ArrayIndexOutOfBoundsException tooFar) {
            LCD.showNumber(1); // shows: 1
        }
    }
}
