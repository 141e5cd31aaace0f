import java.util.ArrayList;
import java.util.LinkedList;
import java.util.List;

public class WorkersAndJobs {
    static class Jobs {
        private final LinkedList<Runnable> waiting = new LinkedList<Runnable>();
        private boolean isClosed;

        synchronized void add(Runnable job) {
            waiting.add(job);
            notify();
        }

        synchronized Runnable next() throws InterruptedException {
            while (waiting.isEmpty() && !isClosed) wait();
            return waiting.isEmpty() ? null : waiting.remove(0);
        }

        synchronized void close() {
            isClosed = true;
            notifyAll();
        }
    }

    static class Worker extends Thread {
        private final Jobs jobs;
        int done;

        Worker(Jobs jobs) {
            this.jobs = jobs;
        }

        @Override
        public void run() {
            try {
                for (Runnable job = jobs.next(); job != null; job = jobs.next()) {
                    job.run();
                    done++;
                }
            } catch (InterruptedException woken) {
                done = -1;
            }
        }
    }

    public static void main(String[] arguments) throws InterruptedException {
        Jobs jobs = new Jobs();
        final List<Integer> results = new ArrayList<Integer>();
        Worker[] workers = {new Worker(jobs), new Worker(jobs), new Worker(jobs)};
        for (Worker worker : workers) worker.start();
        for (int i = 1; i <= 30; i++) {
            final int number = i;
            jobs.add(new Runnable() {
                public void run() {
                    synchronized (results) {
                        results.add(number * number);
                    }
                }
            });
        }
        jobs.close();
        int done = 0;
        for (Worker worker : workers) {
            worker.join();
            done += worker.done;
        }
        int sum = 0;
        for (int result : results) sum += result;
        System.out.println(done + " " + results.size() + " " + sum); // expect 30 30 9455
    }
}
