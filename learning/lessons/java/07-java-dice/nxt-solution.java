import java.util.Random;
import lejos.nxt.*;

public class Throw {
    public static void main(String[] args) throws InterruptedException {
        Random dice = new Random();
        int number = 1 + dice.nextInt(6);
        LCD.drawInt(number, 0, 0);
        for (int i = 0; i < number; i++) {
            Sound.beep();
            Thread.sleep(500);
        }
    }
}
