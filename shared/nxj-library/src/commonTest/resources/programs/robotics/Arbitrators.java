import lejos.robotics.subsumption.Arbitrator;
import lejos.robotics.subsumption.Behavior;

public class Arbitrators {
    static volatile int clock;

    /** Drives until a more important one wants control. */
    static class Drive implements Behavior {
        private volatile boolean isSuppressed;

        public boolean takeControl() {
            return clock < 3;
        }

        public void action() {
            isSuppressed = false;
            System.out.println("drive");
            clock++;
            while (!isSuppressed) Thread.yield();
            System.out.println("suppressed");
        }

        public void suppress() {
            isSuppressed = true;
        }
    }

    /** Avoids something each time after driving. */
    static class Avoid implements Behavior {
        private int done;

        public boolean takeControl() {
            return clock > done;
        }

        public void action() {
            if (done == clock) return; // Called again before the arbitrator's monitor has looked.
            done = clock;
            System.out.println("avoid " + done);
        }

        public void suppress() {
        }
    }

    public static void main(String[] arguments) {
        Arbitrator arbitrator = new Arbitrator(new Behavior[] {new Drive(), new Avoid()}, true);
        arbitrator.start();
        System.out.println("nobody wants control");
    }
}

// It prints:
// expect drive
// expect suppressed
// expect avoid 1
// expect drive
// expect suppressed
// expect avoid 2
// expect drive
// expect suppressed
// expect avoid 3
// expect nobody wants control
