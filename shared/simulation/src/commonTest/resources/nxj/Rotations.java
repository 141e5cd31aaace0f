import lejos.nxt.LCD;
import lejos.nxt.Motor;

/** Turns the free motor, and shows its counts and how long each took. */
public class Rotations {
    public static void main(String[] arguments) throws InterruptedException {
        long start = System.currentTimeMillis();
        Motor.B.rotate(360);
        show(0, start);
        start = System.currentTimeMillis();
        Motor.B.rotate(-360);
        show(1, start);
        Motor.B.resetTachoCount();
        start = System.currentTimeMillis();
        Motor.B.forward();
        Thread.sleep(1000);
        Motor.B.stop();
        show(2, start);
        Motor.B.setSpeed(720);
        Motor.B.resetTachoCount();
        start = System.currentTimeMillis();
        Motor.B.forward();
        Thread.sleep(1000);
        Motor.B.stop();
        show(3, start);
        Motor.B.resetTachoCount();
        start = System.currentTimeMillis();
        for (int turn = 0; turn < 50; turn++) {
            Motor.B.rotate(1);
        }
        show(4, start);
        LCD.refresh();
        Thread.sleep(1000);
    }

    static void show(int row, long start) {
        LCD.drawInt(Motor.B.getTachoCount(), 0, row);
        LCD.drawInt((int) (System.currentTimeMillis() - start), 8, row);
    }
}
