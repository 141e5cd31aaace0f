import lejos.nxt.Button;
import lejos.nxt.ButtonListener;

// button ENTER at 100: pressed
// button ENTER at 200: released
// button LEFT at 400: pressed
// button LEFT at 500: released
// button RIGHT at 700: pressed
// button RIGHT at 800: released
public class PressedButtons {
    static volatile int events;

    public static void main(String[] arguments) throws InterruptedException {
        System.out.println(Button.ENTER.isDown() + " " + Button.readButtons()); // prints: false 0
        int pressed = Button.waitForAnyPress();
        System.out.println(pressed == Button.ID_ENTER); // prints: true
        System.out.println(Button.ENTER.isDown() + " " + Button.ENTER.isUp()); // prints: true false
        Button.LEFT.waitForPressAndRelease();
        System.out.println(Button.LEFT.isDown()); // prints: false
        Button.RIGHT.addButtonListener(new ButtonListener() {
            public void buttonPressed(Button button) {
                System.out.println("pressed " + button.getId()); // prints: pressed 4
                events++;
            }

            public void buttonReleased(Button button) {
                System.out.println("released " + button.getId()); // prints: released 4
                events++;
            }
        });
        while (events < 2) Thread.yield();
        System.out.println(Button.waitForAnyPress(100)); // prints: 0
    }
}
