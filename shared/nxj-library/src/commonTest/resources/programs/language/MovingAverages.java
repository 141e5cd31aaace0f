public class MovingAverages {
    interface Filter {
        double next(double value);
    }

    static class Average implements Filter {
        private final double[] kept;
        private int count;
        private double sum;

        Average(int size) {
            kept = new double[size];
        }

        public double next(double value) {
            int place = count++ % kept.length;
            sum += value - kept[place];
            kept[place] = value;
            return sum / Math.min(count, kept.length);
        }
    }

    static class Median implements Filter {
        private final double[] kept = new double[3];
        private int count;

        public double next(double value) {
            kept[count++ % 3] = value;
            double a = kept[0];
            double b = kept[1];
            double c = kept[2];
            return Math.max(Math.min(a, b), Math.min(Math.max(a, b), c));
        }
    }

    static class Chain implements Filter {
        private final Filter[] filters;

        Chain(Filter... filters) {
            this.filters = filters;
        }

        public double next(double value) {
            for (Filter filter : filters) value = filter.next(value);
            return value;
        }
    }

    public static void main(String[] arguments) {
        double[] distances = {30, 32, 256, 34, 33, 10, 36, 37.5};
        Filter[] filters = {new Average(4), new Median(), new Chain(new Median(), new Average(2))};
        for (Filter filter : filters) {
            String text = "";
            for (double distance : distances) text += filter.next(distance) + " ";
            System.out.println(text.trim());
        }
        // expect 30.0 31.0 106.0 88.0 88.75 83.25 28.25 29.125
        // expect 0.0 30.0 32.0 34.0 34.0 33.0 33.0 36.0
        // expect 0.0 15.0 31.0 33.0 34.0 33.5 33.0 34.5
    }
}
