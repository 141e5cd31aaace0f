// hint: units mixed up
import java.util.Random;
import josx.platform.rcx.*;

public class Throw {
    public static void main(String[] args) throws InterruptedException {
        Random dice = new Random();
        int number = 10 + dice.nextInt(60);
        LCD.showNumber(number);
        for (int i = 0; i < number; i++) {
            Sound.beep();
            Thread.sleep(500);
        }
    }
}
