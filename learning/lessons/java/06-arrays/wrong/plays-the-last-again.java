// hint: line too many
import josx.platform.rcx.*;

public class Tune {
    public static void main(String[] args) throws InterruptedException {
        int[] notes = {262, 330, 392};
        for (int i = 0; i < notes.length; i++) {
            Sound.playTone(notes[i], 30);
            Thread.sleep(400);
        }
        Sound.playTone(notes[0], 30);
        Thread.sleep(400);
    }
}
