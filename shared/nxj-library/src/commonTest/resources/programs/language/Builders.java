public class Builders {
    static class Robot {
        private final String name;
        private final double wheel;
        private final int[] ports;

        private Robot(Builder builder) {
            name = builder.name;
            wheel = builder.wheel;
            ports = builder.ports.clone();
        }

        @Override
        public String toString() {
            String shown = name + " " + wheel;
            for (int port : ports) shown += " " + port;
            return shown;
        }

        static class Builder {
            private String name = "nobody";
            private double wheel = 5.6;
            private int[] ports = {};

            Builder name(String newName) {
                name = newName;
                return this;
            }

            Builder wheel(double diameter) {
                wheel = diameter;
                return this;
            }

            Builder ports(int... newPorts) {
                ports = newPorts;
                return this;
            }

            Robot build() {
                if (wheel <= 0) throw new IllegalStateException("wheel " + wheel);
                return new Robot(this);
            }
        }
    }

    static final class Money implements Comparable<Money> {
        private final long cents;

        Money(long cents) {
            this.cents = cents;
        }

        Money plus(Money other) {
            return new Money(cents + other.cents);
        }

        Money times(double factor) {
            return new Money(Math.round(cents * factor));
        }

        public int compareTo(Money other) {
            return cents < other.cents ? -1 : cents > other.cents ? 1 : 0;
        }

        @Override
        public String toString() {
            long rest = Math.abs(cents % 100);
            return cents / 100 + (rest < 10 ? ".0" : ".") + rest;
        }
    }

    public static void main(String[] arguments) {
        Robot.Builder builder = new Robot.Builder().name("yellow").ports(1, 3);
        System.out.println(builder.build()); // expect yellow 5.6 1 3
        System.out.println(builder.wheel(4.32).name("green").build()); // expect green 4.32 1 3
        System.out.println(new Robot.Builder().build()); // expect nobody 5.6
        try {
            builder.wheel(-1).build();
        } catch (IllegalStateException wrong) {
            System.out.println(wrong.getMessage()); // expect wheel -1.0
        }
        Money price = new Money(1995);
        System.out.println(price.plus(new Money(1010)) + " " + price.times(0.5) + " " + price.times(-1.5)); // expect 30.05 9.98 -29.92
        System.out.println(price.compareTo(new Money(2000)) + " " + new Money(5)); // expect -1 0.05
    }
}
