import lejos.nxt.*;

public class Countdown {
    public static void main(String[] args) throws InterruptedException {
        for (int i = 1; i <= 3; i++) {
            LCD.drawInt(i, 0, 0);
            Thread.sleep(1000);
        }
        Sound.beep();
    }
}
