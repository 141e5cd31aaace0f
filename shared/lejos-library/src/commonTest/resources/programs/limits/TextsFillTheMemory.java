// mode: brick
import josx.platform.rcx.LCD;

public class TextsFillTheMemory {
    public static void main(String[] arguments) {
        int before = (int) System.getRuntime().freeMemory();
        for (int times = 0; times < 10; times++) {
            String text = "again";
        }
        int after = (int) System.getRuntime().freeMemory();
        LCD.showNumber(before - after >= 100 ? 1 : 0); // shows: 1
    }
}
