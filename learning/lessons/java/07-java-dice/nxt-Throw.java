import java.util.Random;
import lejos.nxt.*;

public class Throw {
    public static void main(String[] args) throws InterruptedException {
        Random dice = new Random();
        int number = dice.nextInt(6);
        LCD.drawInt(number, 0, 0);
        Thread.sleep(1000);
    }
}
