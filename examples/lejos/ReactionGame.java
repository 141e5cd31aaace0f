import java.util.Random;
import josx.platform.rcx.Button;
import josx.platform.rcx.LCD;
import josx.platform.rcx.Sound;
import josx.platform.rcx.TextLCD;

/** Press Run after the beep as fast as you can; the display shows the milliseconds. */
public class ReactionGame {
    public static void main(String[] arguments) throws InterruptedException {
        TextLCD.print("READY");
        Thread.sleep(1000 + new Random().nextInt(3000));
        Sound.beep();
        TextLCD.print("GO");
        int began = (int) System.currentTimeMillis();
        while (!Button.RUN.isPressed()) Thread.yield();
        LCD.showNumber((int) System.currentTimeMillis() - began);
    }
}
