#include "segmentation/minimum_cut.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>

#include <cstddef>

namespace partwise {
namespace {

using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
using VertexProperties = boost::property<
    boost::vertex_index_t, long,
    boost::property<boost::vertex_color_t, boost::default_color_type,
                    boost::property<boost::vertex_distance_t, long,
                                    boost::property<boost::vertex_predecessor_t, Traits::edge_descriptor>>>>;
using EdgeProperties =
    boost::property<boost::edge_capacity_t, double,
                    boost::property<boost::edge_residual_capacity_t, double,
                                    boost::property<boost::edge_reverse_t, Traits::edge_descriptor>>>;
using Graph =
    boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, VertexProperties, EdgeProperties>;

void connect(Graph& graph, int from, int to, double capacity, double reverse_capacity) {
  const auto forward = boost::add_edge(from, to, graph).first;
  const auto backward = boost::add_edge(to, from, graph).first;
  boost::put(boost::edge_capacity, graph, forward, capacity);
  boost::put(boost::edge_capacity, graph, backward, reverse_capacity);
  boost::put(boost::edge_reverse, graph, forward, backward);
  boost::put(boost::edge_reverse, graph, backward, forward);
}

}  // namespace

BinaryCut::BinaryCut(int variable_count) : cost_if_set_(static_cast<std::size_t>(variable_count), 0.0) {}

void BinaryCut::add_pair_cost(int i, int j, double cost) {
  if (cost > 0) pairs_.push_back({i, j, cost});
}

std::vector<bool> BinaryCut::minimise() const {
  const int count = static_cast<int>(cost_if_set_.size());
  const int source = count, sink = count + 1;  // x_i = 0 on the source's side
  Graph graph(static_cast<std::size_t>(count) + 2);
  for (int i = 0; i < count; ++i) {
    if (cost_if_set_[i] > 0) connect(graph, source, i, cost_if_set_[i], 0);
    if (cost_if_set_[i] < 0) connect(graph, i, sink, -cost_if_set_[i], 0);
  }
  for (const Pair& pair : pairs_) connect(graph, pair.i, pair.j, pair.cost, 0);
  boost::boykov_kolmogorov_max_flow(graph, source, sink);
  // The vertices from which the sink can still be reached are set; those in neither tree are left at 0.
  std::vector<bool> set(cost_if_set_.size());
  const auto white = boost::color_traits<boost::default_color_type>::white();
  for (int i = 0; i < count; ++i) set[i] = boost::get(boost::vertex_color, graph, i) == white;
  return set;
}

}  // namespace partwise
