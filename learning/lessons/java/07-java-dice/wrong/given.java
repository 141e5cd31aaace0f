// hint: nothing changed
import java.util.Random;
import josx.platform.rcx.*;

public class Throw {
    public static void main(String[] args) throws InterruptedException {
        Random dice = new Random();
        int number = dice.nextInt(6);
        LCD.showNumber(number);
        Thread.sleep(1000);
    }
}
