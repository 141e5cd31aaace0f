import lejos.nxt.Button;

// press ENTER at 200
// press RIGHT at 500 for 300
// press ESCAPE at 1000
public class EventsOfButtons {
    public static void main(String[] arguments) throws InterruptedException {
        System.out.println(Button.waitForAnyEvent(0) == Button.ID_ENTER); // expect true
        System.out.println(Button.waitForAnyEvent(0) == Button.ID_ENTER << 8); // expect true
        Button.discardEvents();
        long before = System.currentTimeMillis();
        System.out.println(Button.waitForAnyEvent(100)); // expect 0
        System.out.println(System.currentTimeMillis() - before >= 100); // expect true
        Button.RIGHT.waitForPress();
        System.out.println(Button.RIGHT.isDown() + " " + Button.LEFT.isDown()); // expect true false
        System.out.println(Button.readButtons() == Button.ID_RIGHT); // expect true
        while (Button.RIGHT.isDown()) Thread.yield();
        Button.discardEvents();
        System.out.println(Button.waitForAnyPress() == Button.ID_ESCAPE); // expect true
        System.out.println(Button.ENTER.getId() + " " + Button.LEFT.getId() + " " + Button.ESCAPE.getId()); // expect 1 2 8
        Button.setKeyClickVolume(0);
        System.out.println(Button.getKeyClickVolume()); // expect 0
    }
}
