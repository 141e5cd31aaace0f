// hint: too many sounds
import java.util.Random;
import josx.platform.rcx.*;

public class Throw {
    public static void main(String[] args) throws InterruptedException {
        Random dice = new Random();
        int number = 1 + dice.nextInt(6);
        LCD.showNumber(number);
        for (int i = 0; i < 10; i++) {
            Sound.beep();
            Thread.sleep(500);
        }
    }
}
