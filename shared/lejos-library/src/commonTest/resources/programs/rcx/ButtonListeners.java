import josx.platform.rcx.Button;
import josx.platform.rcx.ButtonListener;
import josx.platform.rcx.LCD;

public class ButtonListeners implements ButtonListener {
    public void buttonPressed(Button button) {
        LCD.showNumber(button.getId() * 10 + 1); // shows: 41
    }

    public void buttonReleased(Button button) {
        LCD.showNumber(button.getId() * 10); // shows: 40
    }

    public static void main(String[] arguments) throws InterruptedException {
        ButtonListeners listener = new ButtonListeners();
        Button.PRGM.addButtonListener(listener);
        Thread.sleep(500);
        for (int count = 1; count < 4; count++) Button.VIEW.addButtonListener(listener);
        try {
            Button.VIEW.addButtonListener(listener);
            Button.VIEW.addButtonListener(listener);
        } catch (ArrayIndexOutOfBoundsException tooMany) {
            LCD.showNumber(5); // shows: 5
        }
    }
}
// button PRGM at 100: pressed
// button PRGM at 200: released
// ends at 500
