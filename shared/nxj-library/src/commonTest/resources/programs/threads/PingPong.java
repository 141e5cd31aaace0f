public class PingPong {
    private boolean isPing = true;
    private final StringBuilder log = new StringBuilder();

    synchronized void hit(boolean ping, String what) throws InterruptedException {
        while (isPing != ping) wait();
        log.append(what);
        isPing = !ping;
        notifyAll();
    }

    class Player extends Thread {
        private final boolean ping;

        Player(boolean ping) {
            this.ping = ping;
        }

        @Override
        public void run() {
            try {
                for (int i = 0; i < 5; i++) hit(ping, ping ? "ping " : "pong ");
            } catch (InterruptedException woken) {
                log.append("woken");
            }
        }
    }

    public static void main(String[] arguments) throws InterruptedException {
        PingPong game = new PingPong();
        Player first = game.new Player(true);
        Player second = game.new Player(false);
        second.start();
        first.start();
        first.join();
        second.join();
        System.out.println(game.log.toString().trim()); // expect ping pong ping pong ping pong ping pong ping pong
        final Object lock = new Object();
        Thread waiting = new Thread() {
            @Override
            public void run() {
                synchronized (lock) {
                    try {
                        lock.wait();
                        System.out.println("notified");
                    } catch (InterruptedException woken) {
                        System.out.println("interrupted " + isInterrupted()); // expect interrupted false
                    }
                }
            }
        };
        waiting.start();
        Thread.sleep(50);
        waiting.interrupt();
        waiting.join();
    }
}
