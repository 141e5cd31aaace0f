// File names contain content hashes, so that browsers may cache them forever: see docs/hosting.md.
config.output.chunkFilename = '[name].[contenthash:16].js';
config.output.assetModuleFilename = '[name].[contenthash:16][ext]';

// What the page and the worker beside it share of the Java compiler. It has a name because the workers that grade, which
// cannot load chunks by themselves, get it from the page: see `BuiltApp.chunksForWorkers` of the build logic.
config.optimization = config.optimization || {};
config.optimization.splitChunks = {
  cacheGroups: { compiler: { chunks: 'async', minChunks: 2, name: 'ecj-module', enforce: true } },
};

// The compiler for hubs asks for these in Node only.
config.resolve = config.resolve || {};
config.resolve.fallback = { ...config.resolve.fallback, crypto: false, fs: false, path: false };
