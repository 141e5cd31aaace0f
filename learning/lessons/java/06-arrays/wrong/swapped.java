// hint: wrong number
import josx.platform.rcx.*;

public class Tune {
    public static void main(String[] args) throws InterruptedException {
        int[] notes = {330, 262, 392};
        for (int i = 0; i < notes.length; i++) {
            Sound.playTone(notes[i], 30);
            Thread.sleep(400);
        }
    }
}
