import josx.platform.rcx.LCD;

public class OnlyVirtualCallsLock {
    static int count = 0;

    static class Bell {
        public synchronized void ring() {
            notify();
        }

        private synchronized void ringInside() {
            notify();
        }

        void ringByPrivateMethod() {
            ringInside();
        }

        void ringInBlock() {
            synchronized (this) {
                ringInside();
            }
        }
    }

    interface Rings {
        void ring();
    }

    static class LoudBell extends Bell implements Rings {
        void ringBySuper() {
            super.ring();
        }

        synchronized void ringBySuperInside() {
            super.ring();
        }
    }

    static class Adder extends Thread {
        static synchronized void add() {
            int before = count;
            Thread.yield();
            count = before + 1;
        }

        public void run() {
            for (int times = 0; times < 20; times++) add();
        }
    }

    static void ring(LoudBell bell, int way) {
        try {
            if (way == 0) bell.ring();
            if (way == 1) ((Rings) bell).ring();
            if (way == 2) bell.ringInBlock();
            if (way == 3) bell.ringBySuperInside();
            if (way == 4) bell.ringByPrivateMethod();
            if (way == 5) bell.ringBySuper();
            LCD.showNumber(way); // brick shows: 0 1 2 3 // forgiving shows: 0 1 2 3 4 5
        } catch (IllegalMonitorStateException noLock) {
            LCD.showNumber(100 + way); // brick shows: 104 105
        }
    }

    public static void main(String[] arguments) throws InterruptedException {
        LoudBell bell = new LoudBell();
        for (int way = 0; way < 6; way++) ring(bell, way);
        Adder first = new Adder();
        Adder second = new Adder();
        first.start();
        second.start();
        while (first.isAlive() || second.isAlive()) Thread.sleep(10);
        LCD.showNumber(count == 40 ? 1 : 0); // brick shows: 0 // forgiving shows: 1
    }
}
