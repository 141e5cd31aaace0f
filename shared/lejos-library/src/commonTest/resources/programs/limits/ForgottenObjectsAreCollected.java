// mode: forgiving
import josx.platform.rcx.LCD;

public class ForgottenObjectsAreCollected {
    public static void main(String[] arguments) {
        int arrays = 0;
        while (arrays < 1000) {
            int[] forgotten = new int[100];
            arrays++;
        }
        LCD.showNumber(arrays); // shows: 1000
    }
}
