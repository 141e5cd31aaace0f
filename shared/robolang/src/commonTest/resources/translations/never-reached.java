// never-reached.robo, translated by Robotran for leJOS on the RCX.

import josx.platform.rcx.*;

public class NeverReached {
    public static void main(String[] arguments) throws InterruptedException {
        for (int lap = 0; lap < 3; lap++) {
            break;
            // The program never gets to the lines below.
            // Sound.buzz();
        }
        wait4ever();
        Sound.beep();
    }

    static void wait4ever() throws InterruptedException {
        while (true) {
            Thread.sleep(1000);
        }
        // The program never gets to the lines below.

        // Nobody comes here.
        // Sound.beep();
    }
}
