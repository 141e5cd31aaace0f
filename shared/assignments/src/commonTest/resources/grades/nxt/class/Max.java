import lejos.nxt.*;

public class Max {
    static final Object LOCK = new Object();

    public static void main(String[] args) throws Exception {
        new Thread() {
            public void run() {
                synchronized (LOCK) {
                    synchronized (Max.class) {
                        while (true) {
                            Motor.A.rotate(Integer.MAX_VALUE, true);
                            Motor.C.setSpeed(Float.NaN);
                        }
                    }
                }
            }
        }.start();
        Thread.sleep(5);
        synchronized (LOCK) {
            System.exit(0);
        }
    }
}
