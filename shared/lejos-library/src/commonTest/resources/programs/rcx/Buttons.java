import josx.platform.rcx.Button;
import josx.platform.rcx.LCD;

public class Buttons {
    public static void main(String[] arguments) throws InterruptedException {
        LCD.showNumber(Button.RUN.getId() * 100 + Button.VIEW.getId() * 10 + Button.PRGM.getId()); // shows: 124
        LCD.showNumber(Button.BUTTONS.length); // shows: 3
        LCD.showNumber(Button.BUTTONS[0] == Button.RUN ? 1 : 0); // shows: 1
        LCD.showNumber(Button.VIEW.isPressed() ? 1 : 0); // shows: 0
        Thread.sleep(200);
        LCD.showNumber(Button.VIEW.isPressed() ? 1 : 0); // shows: 1
        LCD.showNumber(Button.RUN.isPressed() ? 1 : 0); // shows: 0
        LCD.showNumber(Button.readButtons()); // shows: 2
    }
}
// button VIEW at 100: pressed
// button VIEW at 300: released
