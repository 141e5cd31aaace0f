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
            System.out.println("drive"); // prints 3 times: drive
            clock++;
            while (!isSuppressed) Thread.yield();
            System.out.println("suppressed"); // prints 3 times: suppressed
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
            done = clock;
            System.out.println("avoid " + done); // prints: avoid 1 | avoid 2 | avoid 3
        }

        public void suppress() {
        }
    }

    public static void main(String[] arguments) {
        Arbitrator arbitrator = new Arbitrator(new Behavior[] {new Drive(), new Avoid()}, true);
        arbitrator.start();
        System.out.println("nobody wants control"); // prints: nobody wants control
    }
}
