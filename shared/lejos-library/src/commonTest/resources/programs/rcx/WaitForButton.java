import josx.platform.rcx.Button;
import josx.platform.rcx.LCD;

public class WaitForButton {
    public static void main(String[] arguments) throws InterruptedException {
        Button.RUN.waitForPressAndRelease();
        LCD.showNumber((int) System.currentTimeMillis() >= 400 ? 1 : 0); // shows: 1
    }
}
// button RUN at 200: pressed
// button RUN at 400: released
// ends at 400
