import josx.platform.rcx.LCD;

public class NothingIsCollected {
    public static void main(String[] arguments) {
        int arrays = 0;
        try {
            while (arrays < 1000) {
                int[] forgotten = new int[500];
                arrays++;
            }
        } catch (OutOfMemoryError full) {
            LCD.showNumber(arrays < 8 ? 1 : 0); // brick shows: 1
        }
        if (arrays == 1000) LCD.showNumber(2); // forgiving shows: 2
    }
}
