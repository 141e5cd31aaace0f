import lejos.nxt.Button;
import lejos.nxt.ButtonListener;

// press ENTER at 100
// press LEFT at 400
// press RIGHT at 700
public class PressedButtons {
    static volatile int events;

    public static void main(String[] arguments) throws InterruptedException {
        System.out.println(Button.ENTER.isDown() + " " + Button.readButtons()); // screen false 0
        int pressed = Button.waitForAnyPress();
        System.out.println(pressed == Button.ID_ENTER); // screen true
        System.out.println(Button.ENTER.isDown() + " " + Button.ENTER.isUp()); // screen true false
        Button.LEFT.waitForPressAndRelease();
        System.out.println(Button.LEFT.isDown()); // screen false
        Button.RIGHT.addButtonListener(new ButtonListener() {
            public void buttonPressed(Button button) {
                System.out.println("pressed " + button.getId()); // screen pressed 4
                events++;
            }

            public void buttonReleased(Button button) {
                System.out.println("released " + button.getId()); // screen released 4
                events++;
            }
        });
        while (events < 2) Thread.yield();
        System.out.println(Button.waitForAnyPress(100)); // screen 0
        Thread.sleep(300);
    }
}
