import josx.platform.rcx.LCD;
import josx.platform.rcx.PersistentMemoryArea;

public class PersistentMemory {
    public static void main(String[] arguments) {
        try {
            PersistentMemoryArea.get(4711, 2041);
        } catch (OutOfMemoryError tooMany) {
            LCD.showNumber(2040); // shows: 2040
        }
        int before = (int) System.getRuntime().freeMemory();
        PersistentMemoryArea area = PersistentMemoryArea.get(4711, 10);
        int taken = before - (int) System.getRuntime().freeMemory();
        LCD.showNumber(taken >= 14 && taken < 100 ? 1 : 0); // shows: 1
        LCD.showNumber(area.readByte(9)); // shows: 0
        area.writeByte(9, (byte) 77);
        LCD.showNumber(PersistentMemoryArea.get(4711, 10).readByte(9)); // shows: 77
        try {
            area.readByte(10);
        } catch (ArrayIndexOutOfBoundsException tooFar) {
            LCD.showNumber(3); // shows: 3
        }
    }
}
