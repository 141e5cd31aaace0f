import lejos.nxt.*;

public class Tune {
    public static void main(String[] args) throws InterruptedException {
        int[] notes = {262, 330, 392};
        for (int i = 0; i < notes.length; i++) {
            Sound.playTone(notes[i], 300);
            Thread.sleep(400);
        }
    }
}
