import java.util.BitSet;
import josx.platform.rcx.LCD;

public class BitSets {
    public static void main(String[] arguments) {
        BitSet row = new BitSet(20);
        row.set(0);
        row.set(7);
        row.set(19);
        row.clear(0);
        LCD.showNumber(row.get(0) ? 1 : 0); // shows: 0
        LCD.showNumber(row.get(7) ? 1 : 0); // shows: 1
        LCD.showNumber(row.get(8) ? 1 : 0); // shows: 0
        LCD.showNumber(row.get(19) ? 1 : 0); // shows: 1
    }
}
