import lejos.robotics.subsumption.Arbitrator;
import lejos.robotics.subsumption.Behavior;

/** An arbitrator waits for the first behaviour that wants control, also if it is to end when none does. */
public class LateBehaviours {
    static class Late implements Behavior {
        private int asked;
        private int done;

        public boolean takeControl() {
            asked++;
            return asked > 500 && done < 2;
        }

        public void action() {
            if (done == 2) return; // Called again before the arbitrator's monitor has looked.
            done++;
            System.out.println("action " + done);
        }

        public void suppress() {
        }
    }

    public static void main(String[] arguments) {
        Late late = new Late();
        new Arbitrator(new Behavior[] {late}, true).start();
        System.out.println("over " + (late.asked > 500)); // expect action 1
        // expect action 2
        // expect over true
    }
}
